(** Responses as text. *)

open Scc_json

(** A result. *)
type t =
  | Value of Json.t  (** floats in it are finite *)
  | Fields of (string * t) list
  | Printed of string list  (** an array of texts that are JSON already *)

val of_format : ('a, _) Json_format.t -> 'a -> t
(** The value in the format. *)

val result : Buffer.t -> id:Wire.t -> t -> unit
(** Appends the response with a result. *)

val error : Buffer.t -> id:Wire.t -> Fault.t -> unit
(** Appends the response with an error. *)
