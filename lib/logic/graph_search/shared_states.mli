(** What processes that find transitions see of the states that another one numbers, in memory that they share.
*)

type t

val create : unit -> t option
(** [create ()] is memory for states of which nothing is known yet; [None] if the system gives none. *)

val put : t -> int -> depth:int -> arrival:int -> unit
(** [put t i ~depth ~arrival] notes the depth of state [i] and the number of its earliest arrival, each at least
    0 and below 2{^31}. It raises {!Limits.Over} if there is no more memory. *)

type noted = private int
(** The depth and the arrival of a state, as they were noted at one instant; or nothing. *)

val noted : t -> int -> noted
(** [noted t i] is what was noted of state [i] last. A process may come to know the number of a state before
    anything is noted of it. *)

val is_nothing : noted -> bool
(** [is_nothing n] is true if nothing was noted as yet. *)

val depth_of : noted -> int
(** [depth_of n] is the depth of a state of which something was noted. *)

val arrival_of : noted -> int
(** [arrival_of n] is the number of the arrival of a state of which something was noted. *)

val version : t -> int
(** [version t] changes with each {!improved}. *)

val improved : t -> unit
(** [improved t] notes that the depth or the arrival of a state has changed. *)

val knows_label : t -> int -> bool
(** [knows_label t label] is true after {!note_label}. *)

val note_label : t -> int -> unit
(** [note_label t label] notes that the process that numbers the states knows a label. Labels from 2{^27} on are
    not noted. *)

val may_turn : t -> bool
(** [may_turn t] is true after {!note_turn}. *)

val note_turn : t -> unit
(** [note_turn t] notes that there may be cycles without duration, for which edges will be asked for again. *)

(** {1 What this process has told lately}

    Of tuples that had no number, by their keys. *)

val tell : t -> int -> int -> from:int -> way:int -> told:bool -> unit
(** [tell t key flags ~from ~way ~told] notes what was found of a tuple, at least 0, and that this process has
    told of an edge to it from a state. [way] is equal for two edges only if they stand for equally many
    transitions, and take equally long. Without [told] the edge is not to be relied on. *)

val flags : t -> int -> int
(** [flags t key] is what was found of the tuple; -1 if it is not known any more. *)

val has_told : t -> int -> from:int -> way:int -> bool
(** [has_told t key ~from ~way] is true if this process has told of an edge that leads to the tuple as soon, and
    by as few transitions, as one from this state on this way. Nothing has improved since. *)

val bytes : t -> states:int -> int
(** [bytes t ~states] is about how much memory is taken by so many states, in bytes. *)

