(** Tables of a document: each row once, known by its number. A row is JSON on one line. *)

open Scc_exchange

type t

val create : unit -> t

val add : t -> Json.t -> int
(** The number of the row, from 0, which is a new one if there is none like it. *)

val length : t -> int

val since : t -> int -> string list
(** The rows from that number on, each as JSON. *)

val write : t -> (string -> unit) -> unit
(** As an array, a row on each line. *)
