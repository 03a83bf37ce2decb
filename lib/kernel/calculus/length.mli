(** How long the numbers of a state are. Exact numbers can grow without end: a law that squares a velocity
    doubles its length in each step. *)

type quantity = Position | Velocity | Spin | Orientation | Angular_momentum | Clock

val name : quantity -> string
(** For people: "position", "angular momentum", ... *)

val of_process : State.process -> (quantity * int) list
(** The most bits, numerator and denominator together, that a number of each kind takes. *)

type longest = { quantity : quantity; leaf : int option;  (** the first of its process *) bits : int }

val longest : State.t -> longest
(** The longest number of a state; the first of them, in order of processes. *)
