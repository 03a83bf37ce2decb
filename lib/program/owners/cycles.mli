(** Cycles in which no time passes: runs that go on for ever within one instant. Owners look for one when they have
    explored all. Most explorations have no transition without duration that leads back ({!Part.turning}): there is
    none then, and one round of messages tells so. Else owners follow such transitions from there, and the first
    owner gets them all. *)

(** The graph of an owner. *)
type graph = {
  number : int -> int;  (** of a state, in the order in which a search by one process finds it *)
  find : int -> int option;  (** the state of this owner with a number *)
  level : int -> int;  (** for {!Progress.place}, by the number *)
  is_expanded : int -> bool;
}

type t

val kind : char
(** The kind of the messages with states. *)

val make : Part.t -> Mesh.t -> Records.t array -> t
(** One owner, that may hear of others before it begins itself. *)

val heard : t -> int -> string -> unit
(** [heard c peer text] notes a message of the owner [peer]. *)

val find : t -> graph -> (Progress.place * int list) option
(** The first state on a cycle, by its number, and the choices that lead from there round the cycle; these only at
    the first owner. All owners look at the same time. *)
