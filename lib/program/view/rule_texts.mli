(** The rule book, which is part of the program. *)

val find : string -> string option
(** The text of the entry of a rule, reading or definition by its heading ([Bind], [I-3], [Def-4.2]), in
    Markdown. Lines on code, tests and models are left out. *)
