(** Params as values. Each function refuses values that do not fit, with their places ({!Fault.Refused}:
    [Invalid_params], and [Limit] of [digits]). *)

open Scc_exact

type params
(** The members of an object, with its place. *)

val params : Quotas.t -> (string * Wire.t) list -> params
(** The params of a request. *)

val quotas : params -> Quotas.t
(** The limits of the service. *)

val only : params -> string list -> unit
(** Refuses members with other names than these. *)

val has : params -> string -> bool
(** [has p name] is true if there is a member of this name other than [null]. *)

(** {1 Members, by name} *)

(** Reads a value at a place. *)
type 'a reader = params -> Fault.place -> Wire.t -> 'a

val required : params -> string -> 'a reader -> 'a
(** The value of a member. A missing one, or [null], is refused. *)

val optional : params -> string -> 'a reader -> 'a option
(** The value of a member; [None] if it is missing or [null]. *)

val within : params -> string -> Fault.place
(** The place of a member. *)

(** {1 Values} *)

val value : Wire.t reader
(** Any value, as it is. *)

val rational : Rat.t reader
(** A number, or a text of one, read exactly. *)

val positive : Rat.t reader
(** A number greater than zero. *)

val not_negative : Rat.t reader
(** A number that is at least zero. *)

val natural : int reader
(** An integer from 0 to 2^53. *)

val seed : int64 reader
(** An integer of 64 bits, as a number or a text. *)

val text : string reader
(** A string. *)

val truth : bool reader
(** [true] or [false]. *)

val vector : Vec.t reader
(** An array of three numbers. *)

val matrix : Mat.t reader
(** An array of three rows, each a vector. *)

val quaternion : Quaternion.t reader
(** An array of four numbers w, x, y, z, not all zero. *)

val list : 'a reader -> 'a list reader
(** An array of values. *)

val short_list : 'a reader -> limit:string -> most:int -> 'a list reader
(** An array of at most [most] values. A longer one is refused with the limit of that name before any value is
    read. *)

val fields : params reader
(** An object within the params. *)

val entries : 'a reader -> (string * 'a) list reader
(** An object with any names. *)
