(** Probabilities over all starts, and all instants of splits, that a model leaves open (rules Zones and
    Probability). *)

open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_symbolic
open Scc_regions
open Scc_verify

val serves_all : Model.t -> bool
(** [serves_all m] is true if chance or a law of motion decides something in [m], so that no check is explored
    otherwise. *)

val serves : Model.t -> Property.check -> bool
(** [serves m check] is true if {!serves_all}, or the check asks for a probability or a mean. *)

val refused : Model.t -> (string * string) option
(** What chance decides in such a model that is not followed over zones, in words, and what to do instead. *)

type result = {
  verdict : Verdict.t;
  where : Where.t;  (** the values for which the check holds; all are unknown if it asks for a number *)
  stats : Stats.t;
}

type shared
(** The explorations of the checks of a model. *)

val groups : Property.check list -> (int * Property.check) list list
(** [groups checks] are the checks with their numbers in the list, those together that have
    an until in common, directly or by others. *)

val shared : Property.check list -> shared
(** [shared checks] are the explorations of these checks, none made yet. An exploration is kept as long as one of
    the checks to come asks about the same until. *)

val check :
  Setup.t -> shared -> Semantics.t -> Instant.context -> Uncertain.t -> declared:State.t -> Property.check ->
  (result, Start.fault) Stdlib.result
(** [check options shared semantics c u ~declared check] explores one check by itself, if no check before it has
    made the exploration. The checks come in the order of [shared]. Its statistics are those of new
    explorations. *)
