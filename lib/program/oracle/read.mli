(** Params as values. Each function refuses values that do not fit, with their places ({!Fault.Refused}:
    [Invalid_params], and [Limit] of [digits]). *)

open Scc_exact
open Scc_json

type params
(** The members of an object, with its place. *)

val params : Quotas.t -> (string * Wire.t) list -> params
(** The params of a request. *)

val quotas : params -> Quotas.t
(** The limits of the service. *)

(** Reads a value at a place. [schema] is the schema of the values that are read. *)
type 'a reader = { schema : Json_schema.t; value : params -> Fault.place -> Wire.t -> 'a }

(** {1 Members} *)

type 'a member
(** A member of the params: a name, with what is read there. *)

val member : ?about:string -> string -> 'a reader -> 'a member
(** The member of that name. [about] is its description in the schema. *)

val needs : 'a member -> Json_schema.member
(** The member in the schema of an object that always has it. *)

val may : 'a member -> Json_schema.member
(** The member in the schema of an object that may have it. *)

val only : params -> Json_schema.member list -> unit
(** Refuses members with other names than these. *)

val has : params -> Json_schema.member -> bool
(** [has p m] is true if there is such a member other than [null]. *)

val required : params -> 'a member -> 'a
(** The value of a member. A missing one, or [null], is refused. *)

val optional : params -> 'a member -> 'a option
(** The value of a member; [None] if it is missing or [null]. *)

val required_as : 'a reader -> params -> Wire.t member -> 'a
(** [required_as r p m] is the {!required} value of a member, read by [r]. *)

val place : params -> 'a member -> Fault.place
(** The place of a member. *)

(** {1 Values} *)

val reader : Json_schema.t -> (params -> Fault.place -> Wire.t -> 'a) -> 'a reader
(** A reader of the values of the schema. *)

val map : (params -> Fault.place -> 'a -> 'b) -> 'a reader -> 'b reader
(** [map f r] reads [f] of what [r] reads. *)

val file : string
(** The name of the schema of the messages, for {!Json_format.named}. *)

val defined : string -> Json_schema.t -> Json_schema.t
(** The schema as a definition of this name in [specs/schema/oracle.schema.json]. *)

val value : Json_schema.t -> Wire.t reader
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

val list : ?least:int -> 'a reader -> 'a list reader
(** An array of values. [least] is a bound of its length in the schema alone. *)

val short_list : 'a reader -> limit:string -> (Quotas.t -> int) -> 'a list reader
(** An array of at most so many values. A longer one is refused with the limit of that name before any value is
    read. *)

val any_fields : params reader
(** An object within the params, with any members. *)

val fields : Json_schema.member list -> params reader
(** An object within the params, with no other members than these. *)

val entries : 'a reader -> (string * 'a) list reader
(** An object with any names. *)
