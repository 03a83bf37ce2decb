(** What a model under specs/models says of itself in comments. *)

type verdict = Holds | Bounded | Violated | Measured of string | Undecided

val checks : string -> (string * verdict) list
(** [checks text]: for each line [check NAME : … // expect: VERDICT] the name and the verdict; a check
    without one fails. [holds] is meant exhaustively; [bounded] is up to a bound. *)

val refused : string -> string option
(** The code of a line [// refused: CODE]. *)

val verdict_to_string : verdict -> string
