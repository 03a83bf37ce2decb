(** Tables of a document. Each row occurs once and is referred to by its number. A row is JSON on one line. *)

open Scc_json

(** A table. *)
type t

val create : unit -> t
(** An empty table. *)

val add : t -> Json.t -> int
(** The number of the row, from 0. The row is added if there is no equal one. *)

val since : t -> int -> string list
(** The rows from that number on, each as JSON. *)

val write : t -> (string -> unit) -> unit
(** Writes the table as an array, with a row on each line. *)
