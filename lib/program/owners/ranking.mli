(** The ranks of the new states of a level: their places in the order in which a single search would find them.
    That is the order of their keys: the rank of the state before, and the place of the transition.

    The ranks of the states before are dealt out to the owners in blocks. Each owner tells each other one the
    keys that fall into the block of that one, is told their ranks within the block and the size of the block,
    and adds the sizes of the blocks before. *)

open Scc_codec

val first : width:int -> count:int -> int -> int
(** [first ~width ~count owner] is the first rank of the block of [owner], of [count], in a level of [width]
    states. *)

val segments : width:int -> count:int -> length:int -> before:(int -> int) -> int -> int * int
(** [segments ~width ~count ~length ~before owner] is the places of the keys that fall into the block of [owner],
    the second one excluded. There are [length] keys in order, and [before] has the rank in each. *)

val put_keys : Buffer.t -> keys:(int -> int * int) -> from:int -> stop:int -> unit
(** Appends the keys at these places, the last excluded. *)

(** The rank of the state before, and the place of the transition. *)
type key = { before : int; choice : int }

val read_keys : Packed.source -> low:int -> high:int -> key array
(** Reads keys whose ranks are in this block, the second bound excluded. Raises [Packed.Malformed]. *)

val rank : low:int -> high:int -> key array array -> int * int array array
(** [rank ~low ~high keys] is the number of keys in the block, and the rank of each within the block. [keys] has
    those of each owner in order. *)

val put_ranks : Buffer.t -> total:int -> int array -> unit
(** Appends the size of a block and the ranks of one owner in it. *)

val read_ranks : string array -> segment:(int -> int * int) -> int array
(** [read_ranks texts ~segment] is the ranks of all keys of this owner, from what each owner tells of its block. *)

(** {1 All together} *)

val agree :
  Mesh.t ->
  width:int ->
  length:int ->
  keys:(int -> int * int) ->
  mine:'a ->
  put:(Buffer.t -> 'a -> unit) ->
  read:(Packed.source -> 'a) ->
  'a array * int array
(** [agree mesh ~width ~length ~keys ~mine ~put ~read] is called by all owners: two rounds of messages. [keys k] is
    the rank of the state before, below [width], and the place of the transition, of the [k]-th new state of this
    owner in the order of keys; there are [length]. The result is what each owner tells beside its keys, of which
    [mine] is that of this one, and the ranks of its new states. Raises {!Failure.Failed} for what [read] refuses.
*)
