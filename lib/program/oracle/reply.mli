(** Answers as text. *)

open Scc_exact
open Scc_exchange

type t =
  | Value of Json.t  (** floats in it are finite *)
  | Fields of (string * t) list
  | Printed of string list  (** an array of what is JSON already *)

val quantity : Rat.t -> Json.t
(** [{"exact": "5/4", "float": 1.25}]. *)

val nullable : ('a -> Json.t) -> 'a option -> Json.t

val result : Buffer.t -> id:Wire.t -> t -> unit
(** Adds the response. *)

val error : Buffer.t -> id:Wire.t -> Fault.t -> unit
