(** The values of the states of an MDP, as far as they were wanted, and a scheduler. *)

type t

type asked =
  | All  (** all states *)
  | States of int list  (** these states; states that they do not lead to cost nothing *)

val value : t -> int -> Answer.t
(** [value t s] is the value of state [s]. For a state that was neither wanted nor is reached from a wanted one,
    and whose value the graph does not decide, it is the interval of all possible values. *)

val scheduler : t -> int array
(** [scheduler t] is a choice for each state, numbered from 0 among the choices of the state. It counts for the
    states that were wanted and those that they lead to. Taken at each visit, these choices attain exact values.
    For intervals, their values are at least the lower ends for greatest values. For least values they are at most
    the upper ends, where these are known. *)

(** How the values that the graph does not decide were computed. *)
type found =
  | By_graph  (** the graph decides all values *)
  | In_rationals  (** by {!Exact_solver} *)
  | In_intervals of { sweeps : int; not_exact : Exact_solver.given_up option }
  (** By {!Interval_solver}, in so many sweeps; [not_exact] is the reason why exact values were given up, for the
      engine [Either]. *)
  | Given_up of Exact_solver.given_up  (** {!Exact_solver} gave up, and values are the possible ones *)

val found : t -> found
(** [found t] is the way in which the values were computed. *)

(** {1 For questions} *)

(** What is solved: {!Equations.make}, and what the graph alone decides. It depends on no probability. *)
type problem = {
  direction : Equations.direction;
  status : int -> Equations.status;
  elsewhere : Answer.t;  (** the value of the states with the status [Elsewhere] *)
  allowed : int -> bool;
  merged : Components.ends;
  rewards : bool;  (** without them values are at most 1 *)
  choice : int -> int;
  (** the choice, numbered through, that attains the known value of a state, or -1 if any does *)
}

val equations : Backwards.t -> problem -> asked:(int -> bool) option -> Equations.t
(** [equations b problem ~asked] is the equations of the problem on the MDP of [b]. *)

val solve : Backwards.t -> Effort.t -> asked:asked -> problem -> t
(** [solve b effort ~asked problem] solves the problem on the MDP of [b]. *)
