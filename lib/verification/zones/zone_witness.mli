(** Witnesses of results on a graph of zones. A start and instants of splits are chosen. The run is followed
    through the rules of the ordinary model for these values before it is shown. *)

open Scc_calculus
open Scc_semantics
open Scc_symbolic
open Scc_explain

val make :
  Semantics.t -> Uncertain.t -> declared:State.t -> sliced:bool -> Concrete.t -> Search_sets.place -> Witness.t
(** The run to a place, of the whole network. With [sliced] the given run is one of a slice ({!Zone_slice}),
    and the processes left out are added with their urgent transitions. It is a bug if the run cannot be
    followed, or if the predicate does not hold at its end. *)

val of_run : Semantics.t -> Uncertain.t -> declared:State.t -> Shown_run.t -> Witness.t
(** A run of the whole network that decides a formula, with the reasons. Every state predicate of these is
    evaluated again, along the whole run ({!Zone_established}). It is a bug if one differs from its claim. *)
