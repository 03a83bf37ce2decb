(** The states of all owners as the nodes of one graph, numbered from 0, the initial state. All owners number their
    states at the same time, by rounds of messages. *)

type t = {
  size : int;  (** states of all owners *)
  number : int -> int;  (** the number of a state of this owner *)
}

val by_levels : Mesh.t -> Levels.t -> t
(** In the order in which a single search finds them. *)

val by_turns : Mesh.t -> Part.t -> Clock.t -> turns:int -> t
(** In the order of their turns, of which there are so many. *)

val as_they_come : Mesh.t -> Part.t -> home:int -> t
(** Owner by owner, from [home] on, which has the initial state first. *)
