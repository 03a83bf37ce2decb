(** Params as values. Everything here refuses what does not fit ({!Fault.Refused}: [Invalid_params], and [Limit] of
    [digits]), with its place. *)

open Scc_exact

type params
(** The members of an object, and where it is. *)

val params : Quotas.t -> (string * Wire.t) list -> params
(** Of a request. *)

val quotas : params -> Quotas.t

val only : params -> string list -> unit
(** That there are no members but these. *)

val has : params -> string -> bool

(** {1 Members, by name} *)

type 'a reader = params -> Fault.place -> Wire.t -> 'a

val required : params -> string -> 'a reader -> 'a
val optional : params -> string -> 'a reader -> 'a option
(** [null] is no value. *)

val within : params -> string -> Fault.place
(** The place of a member. *)

(** {1 Values} *)

val value : Wire.t reader
val rational : Rat.t reader
val positive : Rat.t reader
val not_negative : Rat.t reader

val natural : int reader
(** At most 2^53. *)

val seed : int64 reader
(** A JSON integer, or a text of one. *)

val text : string reader
val truth : bool reader
val vector : Vec.t reader
val matrix : Mat.t reader

val quaternion : Quaternion.t reader
(** Not all zero. *)

val list : 'a reader -> 'a list reader
val short_list : 'a reader -> limit:string -> most:int -> 'a list reader
(** The same of at most so many, or else refused by the quota of that name before any of them is read. *)

val fields : params reader
(** An object within. *)

val entries : 'a reader -> (string * 'a) list reader
(** An object with any names. *)
