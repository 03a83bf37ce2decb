(** Requests that the tests of the oracle share. *)

type json = Yojson.Basic.t

val cube : json
(** Params of [shape.define]: a cube of side 2 about the origin. *)

val tetrahedron : json

val model : string
(** Two cubes that meet, bind and bounce, and a wall. *)

val request : id:int -> string -> json -> json

val setup : json list
(** Defines the cube as [s1], the tetrahedron as [s2] and loads the model as [m1]; ids from 1. *)

val valid : (string * json) list
(** Methods with params that have answers after {!setup}. *)
