Require Import Reals.
From Slipbook Require Import Motion Formulas.
