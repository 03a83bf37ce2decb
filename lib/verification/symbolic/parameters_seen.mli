(** The parameters that distinguish states of which only what follows them matters (rule Starts). *)

open Scc_property
open Scc_state_sets

type t
(** Parameters of a model. *)

val all : Instant.context -> t
(** All parameters that have ranges. *)

val make : Instant.context -> Property.prop list -> Zone.t list -> t
(** [make c predicates zones] are the parameters that the predicates mention, and those on which delays or the
    places of parts depend, in the zones and in all that follows them. *)

val forget : t -> Zone.t -> Zone.t
(** [forget t z] is [z] with 0 in the place of the other parameters. What follows its states is the same. *)
