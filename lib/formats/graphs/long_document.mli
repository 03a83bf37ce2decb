(** Documents that end with a long array. They are written piece by piece, with a line for each row. *)

open Scc_json

type ('o, 'row) t = {
  head : ('o, unit) Json_format.members;  (** the members before the array *)
  rows : string;  (** the name of the array *)
  about : string;  (** its description in the schema *)
  row : ('row, unit) Json_format.t;
  get : 'o -> int * (int -> 'row);  (** how many rows there are, at least one, and each by its number from 0 *)
}

val format : ('o, _) t -> ('o, unit) Json_format.t
(** The format of the whole document. *)

val write : ('o, _) t -> 'o -> (string -> unit) -> unit
(** Writes the document. A row is made when it is written, as there may be many. *)
