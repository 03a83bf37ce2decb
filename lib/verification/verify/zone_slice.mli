(** Slicing over zones (rule Slice): what cannot influence a search for any values of the parameters, whatever the
    instants of splits are, is left out of the network.

    This is {!Scc_state_space.Slice} where places are affine in the parameters. Two groups are together if they may
    meet for {i some} values. What is left out then meets nothing that is kept for any of them, so that for each
    value by itself the slice does for the whole: verdicts, and sets of values, are those of the whole. *)

open Scc_calculus
open Scc_property
open Scc_symbolic

val make : Instant.context -> Uncertain.t -> initial:State.t -> Zone.t -> Property.temporal list -> State.t option
(** The slice of an initial state for all the formulas together, from one of the zones of all starts
    ({!Start.zones}), whose places hold for all of them; [None] when nothing can be left out, or a formula is not
    of the fragment. *)
