(** Which checks are explored together over zones. *)

open Scc_calculus
open Scc_property

type t = {
  keeps_time : bool;  (** model time is a coordinate *)
  part : State.t option;  (** the slice that does for all of them; [None]: the whole network *)
  members : (int * Property.check) list;  (** with their places in the list of all *)
  premises : (int * Property.check) list;
  (** likewise: what has to come true for members of their names to say anything. It is looked for on the way, and
      keeps nothing going. *)
}

val make :
  bounded:bool -> part:(Property.check -> State.t option) -> premises:Property.check list -> Property.check list ->
  t list
(** [bounded]: there is a bound of time for all. At least one, which has no members where there are no checks. The
    part of a check has to do for the premises of its name as well. *)
