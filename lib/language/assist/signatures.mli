(** How what is being called at a place is called. *)

(** A call that is being written. *)
type t = {
  forms : string list;  (** all ways to call it, such as ["bound(body, body)"] *)
  argument : int;  (** the number of the argument at the place, from 0 *)
  about : string option;  (** what it means *)
}

val at : Known.t -> string -> int -> t option
(** The innermost call of a function, an atom, an event, a solid or a family whose brackets contain an offset. *)

val arguments : string -> (int * int) list
(** The places of the arguments within a form, as offsets of their beginnings and ends. *)
