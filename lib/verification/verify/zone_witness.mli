(** Witnesses from what was found on a graph of zones: a start and instants of splits are chosen, and the run is
    followed through the rules of the ordinary model that this is, before anyone is shown it. *)

open Scc_calculus
open Scc_semantics
open Scc_symbolic
open Scc_explain

val make :
  Semantics.t -> Uncertain.t -> declared:State.t -> sliced:bool -> Concrete.t -> Search_sets.place -> Witness.t
(** With [sliced] the run is one of a slice ({!Zone_slice}): what was left out does in it what it must, and the run
    is shown as one of the whole network. It is a bug if the run cannot be followed, or the predicate does not hold
    where it leads. *)

val of_run : Semantics.t -> Uncertain.t -> declared:State.t -> Shown_run.t -> Witness.t
(** A run of the whole network that decides a formula, with the reasons. Every state predicate that these are about
    is judged anew, along the whole run ({!Zone_established}): it is a bug if one is not as it was claimed. *)
