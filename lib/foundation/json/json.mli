(** JSON as scc writes and reads it. Writing is deterministic: members keep their order, and there are no floats
    (a float is a bug). *)

open Scc_base
open Scc_exact

(** A value of JSON. *)
type t =
  [ `Null
  | `Bool of bool
  | `Int of int
  | `Float of float
  | `String of string
  | `List of t list
  | `Assoc of (string * t) list ]

(** {1 Writing} *)

val text : string -> t
(** A string. Bytes that are not UTF-8 become U+FFFD, so the result is always JSON. *)

val fraction : Rat.t -> string
(** The text ["p/q"] in lowest terms, with q > 0 written even if it is 1. *)

val rat : Rat.t -> t
(** The string of {!fraction}. *)

val vec : Vec.t -> t
(** An array of three rationals. *)

val option : ('a -> t) -> 'a option -> t
(** [option f x] is [f] of the value, or [null] for [None]. *)

val line : t -> string
(** The text on one line, without a line end. *)

val pretty : t -> string
(** The text with a line end. Arrays and objects that do not fit in 88 bytes are on several lines. *)

val pretty_pieces : (string -> unit) -> t -> unit
(** [pretty_pieces put json] calls [put] with {!pretty} of [json] in pieces of about 64 KiB, in order. *)

(** {1 Reading} *)

val parse : Source.t -> (t, Diag.t) result
(** Reads the whole text as one value. Other texts, and values nested deeper than 200, are SC0801. *)

val parse_line : Source.t -> start:int -> stop:int -> (t, Diag.t) result
(** [parse_line source ~start ~stop] reads the text between two offsets as one value, with the errors of
    {!parse}. *)

val member : string -> t -> t option
(** [member key v] is the member [key] of the object [v]. It is [None] if [v] is no object or the member is
    [null]. *)

val string : t -> string option
(** The text of a string, and [None] for any other value. *)

val int : t -> int option
(** The value of an integer, and [None] for any other value. *)

val list : t -> t list option
(** The items of an array, and [None] for any other value. *)

val rational : t -> Rat.t option
(** The number of a string ["p/q"], a decimal string or a JSON integer, and [None] for any other value. *)
