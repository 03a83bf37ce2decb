(** Groups of checks that are explored together over zones. *)

open Scc_calculus
open Scc_property

type t = {
  keeps_time : bool;  (** model time is a coordinate *)
  part : State.t option;  (** the slice that is enough for all of them; [None]: the whole network *)
  members : (int * Property.check) list;  (** with their places in the list of all *)
  premises : (int * Property.check) list;
  (** the premises of members with their names, also with places. They are searched for on the way, and prolong
      no exploration. *)
}

val make :
  bounded:bool -> part:(Property.check -> State.t option) -> premises:Property.check list -> Property.check list ->
  t list
(** [make ~bounded ~part ~premises checks] are the groups, at least one; it has no members if there are no
    checks. With [bounded], there is a bound of time for all. The part of a check has to be enough for the
    premises of its name as well. *)
