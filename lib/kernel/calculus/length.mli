(** How long the numbers of a state are. Exact numbers can grow without end: a law that squares a velocity
    doubles its length in each step. *)

type quantity = Position | Velocity | Spin | Orientation | Angular_momentum | Clock

val name : quantity -> string
(** The name of a quantity in messages: "position", "angular momentum"; "time" for a [Clock]. *)

val of_process : State.process -> (quantity * int) list
(** The greatest length in bits, numerator and denominator together, of the numbers of each kind in a process. *)

type longest = { quantity : quantity; leaf : int option;  (** the first of its process *) bits : int }

val longest : State.t -> longest
(** The longest number of a state. Of equally long ones the first: those of the network itself (leaf [None]), then
    those of the processes in order. *)
