(** The options of [scc check] for its exploration, and for outputs beside the verdicts. *)

(** The options as given. *)
type t = {
  checks : string list;  (** the names of those to decide; none stands for all *)
  witness : string option;  (** a folder for schedules *)
  coverage : bool;
  stats : bool;
  sarif : string option;  (** a file *)
  reductions : Scc_state_space.Reduction.kind list;
  order : Scc_state_space.State_graph.order;
  compact : bool;  (** hash compaction *)
  where : bool;  (** report the values of parameters for which properties hold *)
  smt : string option;  (** a file for these values, as SMT-LIB *)
  draw : string option;  (** a file for a drawing of these values *)
  axes : string list;  (** the parameters to draw *)
  slice : (string * Scc_exact.Rat.t) list;  (** values of other parameters in the drawing *)
  prove : bool;  (** search for an invariant first *)
  invariant : string option;  (** a file for the invariant *)
  parametric : string option;  (** a parameter of which answers are functions *)
  contrast : bool;  (** with each run one that does otherwise *)
  curve : string option;  (** a check, whose probability is reported for all shorter times, too *)
  plot : string option;  (** a file for a plot of this curve *)
  full : bool;  (** report runs in full *)
  jobs : int option;  (** the number of processes; [None]: as many as there are cores, once it pays *)
  store : string option;  (** a folder *)
}

val term : t Cmdliner.Term.t
(** All options of this record. *)

val explored :
  t -> checks:Scc_property.Property.check list -> Scc_verdicts.Budget.t -> (string * string) list
(** The options on which a graph of these checks depends, with their values, by name. Options that only end the
    work early are left out. *)

val reductions : Scc_state_space.Reduction.kind list Cmdliner.Term.t
(** The option [--no-reduce]: the reductions that remain. *)
