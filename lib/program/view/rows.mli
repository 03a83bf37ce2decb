(** Tables of a document. Each row occurs once and is referred to by its number. A row is JSON on one line. *)

open Scc_json

val named : string -> ?text:string -> ('w, 'r) Json_format.t -> ('w, 'r) Json_format.t
(** [named name ~text t] is [t] as a definition of [specs/schema/view.schema.json]. [text] is its description. *)

val number : (int, int) Json_format.t
(** The number of a row. *)

(** A table. *)
type t

val create : unit -> t
(** An empty table. *)

val add : t -> ('w, _) Json_format.t -> 'w -> int
(** The number of the row of a value, from 0. The row is added if there is no equal one. *)

val since : t -> int -> string list
(** The rows from that number on, each as JSON. *)

val write : t -> (string -> unit) -> unit
(** Writes the table as an array, with a row on each line. *)
