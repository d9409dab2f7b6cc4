From Slipbook Require Export TableMotions.
