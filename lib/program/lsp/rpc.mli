(** Messages of JSON-RPC 2.0, as the protocol uses them. *)

open Scc_json

(** A message of the client. *)
type message =
  | Request of { id : Json.t; name : string; params : Json.t }
  | Notification of { name : string; params : Json.t }
  | Response of { id : Json.t; result : Json.t option }  (** to a request of the server; no result: an error *)
  | Invalid of { id : Json.t; code : int; why : string }  (** what cannot be carried out *)

val read : string -> message
(** Reads the text of a message. Batches, which the protocol does not have, are invalid. *)

exception Refused of int * string
(** A request cannot be carried out: the code of its error, and why. *)

val refuse : int -> ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Refused}. *)

(** {1 Codes of errors} *)

val parse_error : int
(** A text that is no JSON. *)

val invalid_request : int
(** JSON that is no message, or a message at the wrong time. *)

val unknown_method : int
(** A method that the server does not have. *)

val invalid_params : int
(** Params that are missing or of the wrong kind. *)

val internal_error : int
(** A fault of the program. *)

val not_initialized : int
(** A request before [initialize]. *)

val failed : int
(** A request that is well-formed but cannot be met. *)

val cancelled : int
(** A request that the client has cancelled. *)

val same_id : Json.t -> Json.t -> bool
(** [same_id a b] is true if two ids, or two tokens of progress, are one: equal texts or integers. *)

(** {1 Params} *)

val member : string -> Json.t -> Json.t
(** The member of an object; raises {!Refused} with {!invalid_params} if there is none. *)

val string : string -> Json.t -> string
(** The text of a member; raises {!Refused} with {!invalid_params}. *)

val int : string -> Json.t -> int
(** The integer of a member; raises {!Refused} with {!invalid_params}. *)

val list : string -> Json.t -> Json.t list
(** The items of a member; raises {!Refused} with {!invalid_params}. *)

val position : Json.t -> int * int
(** A line and a character; raises {!Refused} with {!invalid_params}. *)

(** {1 Messages of the server} *)

val answer : id:Json.t -> Json.t -> Json.t
(** The answer to a request. *)

val error : id:Json.t -> int -> string -> Json.t
(** The answer to a request that failed. *)

val notification : string -> Json.t -> Json.t
(** A notification. *)

val request : id:int -> string -> Json.t -> Json.t
(** A request of the server. *)
