(** The rule book, carried along. *)

val find : string -> string option
(** The text of the entry of a rule, reading or definition by its heading ([Bind], [I-3], [Def-4.2]), in Markdown,
    without the lines that say where its code and tests are. *)
