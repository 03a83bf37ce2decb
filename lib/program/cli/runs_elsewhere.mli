(** Runs of an estimation that other processes make: [scc estimate --elsewhere] asks for them and judges them, and
    [scc estimate --make] makes them (`specs/cluster.md`). Both are of one build, as the outcomes are
    marshalled. *)

(** Which runs: those from one number to another one, which is excluded, of a turn. The questions of an estimation
    are asked in turns, from 1; turn 0 asks all of them. *)
type wanted = { turn : int; from : int; upto : int }

val conv : wanted Cmdliner.Arg.conv
(** [TURN:FROM-TO]. *)

val digest : (string * string) list -> string
(** The digest of the identity of an estimation ({!Kept.identity}), in hexadecimal digits. *)

(** {1 Making them} *)

val make : wanted -> of_:string -> whole:('a -> bool) -> (int -> 'a) -> bool
(** [make wanted ~of_ ~whole work] writes a line with [wanted] and the digest [of_], and a line for each run, from
    [work]. It is false if a run was not [whole]: that one and the others are not written. *)

(** {1 Having them made} *)

type t
(** Standard output, where runs are asked for, and standard input, from which they come. *)

val start : of_:string -> t
(** Nothing is asked for as yet. [of_] is the digest. *)

val run :
  t ->
  turn:int ->
  first:int ->
  count:int ->
  interrupted:(unit -> bool) ->
  each:(int -> 'a -> unit) ->
  (unit, Scc_workers.Pool.stop) result
(** [run t ~turn ~first ~count ~interrupted ~each] asks for the runs from [first] on, below [count], and calls
    [each] for them in order. Their outcomes must be of type ['a]: the digest ensures that. *)
