(** When nothing is left to do anywhere, and nothing is under way (Safra's algorithm: E. W. Dijkstra, EWD 998,
    1987). A token goes round all owners. It adds up how many more messages each has sent than received, and
    becomes black at an owner that has received one since the token was there before. Everything is over when it
    comes back white, the first owner has received none meanwhile, and the sum with its own number is 0. *)

type colour = White | Black

(** What goes round. *)
type token = { sum : int; colour : colour }

(** One owner. *)
type t

val make : first:bool -> t
(** An owner that has sent and received nothing. The first one sends the token round. *)

val sent : t -> int -> unit
(** [sent t n]: it has sent [n] messages. *)

val received : t -> unit
(** It has received a message. *)

val arrived : t -> token -> unit
(** The token has come. *)

(** What is to be done. *)
type turn =
  | Wait
  | Pass of token  (** to the next owner *)
  | Over  (** everything is over, everywhere *)

val idle : t -> turn
(** The owner has nothing left to do at present. *)
