(* The former name of these files; section 2.2 imports it. *)
From Slipbook Require Export HalfPeriod Drawn Line.
