(** Slicing over zones (rule Slice): processes are left out of the network if they cannot influence a search,
    for any values of the parameters and any instants of splits.

    This is {!Scc_state_space.Slice} where places are affine in the parameters. Two groups are together if they
    may meet for {i some} values. So the processes left out meet no others for any values, and for each value
    the slice is enough. Verdicts, and sets of values, are those of the whole. *)

open Scc_calculus
open Scc_property
open Scc_state_sets
open Scc_symbolic

val make : Instant.context -> Uncertain.t -> initial:State.t -> Zone.t -> Property.temporal list -> State.t option
(** The slice of an initial state for all the formulas together. The zone is one of those of all starts
    ({!Start.zones}); its places are valid for all of them. [None] if nothing can be left out, or a formula is
    not of the fragment. *)
