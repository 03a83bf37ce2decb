(** The entries of specs/rulebook.md and specs/deviations.md: a heading [### ID …] and, in its section, lines
    [- Code: FILE NAME], [- Test: FILE "NAME"], [- Model: PATH]. *)

type entry = {
  id : string;
  line : int;  (** of the heading *)
  chapter : string;  (** the title of the chapter that it is in, without its number: ["Laws"] *)
  code : (string * string) list;  (** file, function *)
  tests : (string * string) list;  (** file, part of the name of a case *)
  models : string list;
  malformed : string list;  (** lines that begin like one of these and do not go on so *)
}

val entries : string -> entry list
(** Of the text of a book. *)
