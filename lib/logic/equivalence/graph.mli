(** Labelled graphs: states from 0, one of them initial, and labelled edges, some labels being the silent
    action tau. Edges of a state are sorted by label and target, and no edge is there twice. Ten million edges
    take about 80 MB. *)

type t = private {
  size : int;  (** number of states, at least 1 *)
  initial : int;
  labels : string array;  (** the first is {!tau}; no two are equal *)
  first : Scc_data.Int_array.t;  (** [size + 1] numbers: the edges of s are from [first s] to [first (s+1)] *)
  label : Scc_data.Int_array.t;  (** of each edge *)
  target : Scc_data.Int_array.t;
  unknown : Scc_data.Bits.t;  (** the states not all of whose edges are known *)
}

val tau : string
(** The text of the silent action: ["tau"]. Its number is 0. *)

val is_tau : int -> bool
val edges : t -> int
(** How many. *)

val known : t -> int -> bool
(** Every edge of the state is there. *)

val complete : t -> bool
(** {!known} of every state. *)

val iter : t -> int -> (int -> int -> unit) -> unit
(** [iter g s f] is [f label target] for each edge of [s], in order. *)

val exists : t -> int -> (int -> int -> bool) -> bool

(** {1 Making} *)

type builder

val builder : unit -> builder

val intern : builder -> string -> int
(** The number of a label, new or not. *)

val add : builder -> source:int -> label:int -> target:int -> unit

val finish : builder -> size:int -> initial:int -> unknown:(int -> bool) -> t
(** Sorts and drops repetitions, in time linear in states, edges and labels. Sources, targets and the initial
    state are below [size]. *)

val map_labels : t -> (string -> string) -> t
(** Every label through the function; [tau] stays. Labels that become {!tau} become silent. *)

val union : t -> t -> t * int
(** Both side by side: the states of the second come after those of the first. The initial state is the
    first's; the number is the second's. *)

val reachable : t -> t
(** The part that can be reached from the initial state, which becomes state 0; the others are numbered in
    breadth-first order. *)

val merge : t -> (int -> int) -> size:int -> drop_silent_loops:bool -> t
(** [merge g f ~size] is the graph whose states are the values of [f], each with the edges of all states that
    it stands for. *)

(** {1 Edges backwards} *)

type backwards

val backwards : t -> backwards

val sources : backwards -> int -> (int -> int -> unit) -> unit
(** [sources b s f] is [f label source] for each edge that leads to [s]. *)
