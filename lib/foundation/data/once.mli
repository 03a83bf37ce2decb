(** A cache of values that are made once for each key and kept as long as the cache. *)

module Make (Key : Hashtbl.HashedType) : sig
  type 'a t

  val create : (Key.t -> 'a) -> 'a t
  (** [create make] is an empty cache. *)

  val find : 'a t -> Key.t -> 'a
  (** [find t key] is [make key], made at the first call for an equal key. *)
end
