(** Responses as text. *)

open Scc_exact
open Scc_json

(** A result. *)
type t =
  | Value of Json.t  (** floats in it are finite *)
  | Fields of (string * t) list
  | Printed of string list  (** an array of texts that are JSON already *)

val quantity : Rat.t -> Json.t
(** An object with the exact number and the nearest float: [{"exact": "5/4", "float": 1.25}]. The float is
    [null] if it is not finite. *)

val result : Buffer.t -> id:Wire.t -> t -> unit
(** Appends the response with a result. *)

val error : Buffer.t -> id:Wire.t -> Fault.t -> unit
(** Appends the response with an error. *)
