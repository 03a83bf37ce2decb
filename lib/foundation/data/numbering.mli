(** Numbers from 0 for keys, in the order in which they first come. *)

module Make (Key : Hashtbl.HashedType) : sig
  type t

  val create : unit -> t
  (** A numbering without keys. *)

  val number : t -> Key.t -> int
  (** [number t key] is the number of [key], the next one if it is new. *)

  val size : t -> int
  (** [size t] is how many keys have a number. *)

  val get : t -> int -> Key.t
  (** [get t n] is the key with the number [n], which must exist (a bug otherwise). *)

  val keys : t -> Key.t list
  (** [keys t] are the keys in the order of their numbers. *)
end
