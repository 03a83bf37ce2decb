(** JSON as received: strictly that of RFC 8259, with numbers as they are written. *)

(** A value of JSON. *)
type t =
  | Null
  | Bool of bool
  | Number of string  (** as written, so that it can be read exactly *)
  | Text of string  (** valid UTF-8 *)
  | List of t list
  | Object of (string * t) list  (** in order, no name twice *)

val parse : Quotas.t -> string -> (t, Fault.t) result
(** The whole of a line as one value. Errors: [Parse], and [Limit] of [depth] and [values]. The stack is bounded
    by the limit of depth; names of members count as values. *)
