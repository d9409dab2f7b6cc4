From Slipbook Require Export TableLaws.
