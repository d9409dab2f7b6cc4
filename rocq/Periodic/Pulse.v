(* The former name of this file; section 2.2 imports it. *)
From Slipbook Require Export HalfPeriod.
