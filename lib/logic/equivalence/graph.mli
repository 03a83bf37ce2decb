(** Labelled graphs: states from 0, one of them initial, and labelled edges. Label 0 is the silent action tau. The
    edges of a state are sorted by label and target, without repetitions. Ten million edges take about 80 MB. *)

type t = private {
  size : int;  (** number of states, at least 1 *)
  initial : int;
  labels : string array;  (** the first is {!tau}; no two are equal *)
  first : Scc_data.Int_array.t;  (** [size + 1] numbers: the edges of s are from [first s] to [first (s+1)] *)
  label : Scc_data.Int_array.t;  (** the label of each edge, an index of [labels] *)
  target : Scc_data.Int_array.t;  (** the target of each edge *)
  unknown : Scc_data.Bits.t;  (** the states whose edges are not all known *)
}

val tau : string
(** The text of the silent action: ["tau"]. Its number is 0. *)

val is_tau : int -> bool
(** [is_tau label] is true for the number of the silent action, 0. *)

val edges : t -> int
(** [edges g] is the number of edges. *)

val known : t -> int -> bool
(** [known g s] is true if all edges of state [s] are known. *)

val complete : t -> bool
(** [complete g] is true if all edges of all states are known. *)

val iter : t -> int -> (int -> int -> unit) -> unit
(** [iter g s f] calls [f label target] for each edge of [s], in order. *)

val exists : t -> int -> (int -> int -> bool) -> bool
(** [exists g s f] is true if [f label target] is true for some edge of [s]. *)

(** {1 Making} *)

type builder

val builder : unit -> builder
(** [builder ()] has no edges, and only the label {!tau}. *)

val intern : builder -> string -> int
(** [intern b text] is the number of the label [text]; a new label gets the next number. *)

val add : builder -> source:int -> label:int -> target:int -> unit
(** [add b ~source ~label ~target] adds an edge; [label] is a number from {!intern}. *)

val finish : builder -> size:int -> initial:int -> unknown:(int -> bool) -> t
(** [finish b ~size ~initial ~unknown] is the graph with these edges, sorted and without repetitions. States that
    pass [unknown] have further edges that are not known. Sources, targets and the initial state are below [size].
    It takes time linear in states, edges and labels, apart from sorting the edges of each state. *)

val map_labels : t -> (string -> string) -> t
(** [map_labels g f] is the graph with each label replaced by its image under [f]; {!tau} stays. Labels that become
    {!tau} become silent. *)

val union : t -> t -> t * int
(** [union g h] is both graphs side by side: the states of [h] come after those of [g]. The initial state is that
    of [g]; the number is that of the initial state of [h]. *)

val reachable : t -> t
(** [reachable g] is the part that can be reached from the initial state. States are numbered in breadth-first
    order; the initial state becomes 0. *)

val merge : t -> (int -> int) -> size:int -> drop_silent_loops:bool -> t
(** [merge g f ~size ~drop_silent_loops] is the graph whose states are the values of [f], below [size]. Each has
    the edges of all states that it stands for, without silent loops if [drop_silent_loops]. It is unknown if one
    of them is. *)

(** {1 Edges backwards} *)

type backwards

val backwards : t -> backwards
(** [backwards g] is the reversed edges, computed in linear time. *)

val sources : backwards -> int -> (int -> int -> unit) -> unit
(** [sources b s f] calls [f label source] for each edge that leads to state [s]. *)
