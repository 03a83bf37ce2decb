(** Requests that the tests of the oracle share. *)

type json = Yojson.Basic.t

val cube : json
(** Params of [shape.define]: a cube of side 2 about the origin. *)

val tetrahedron : json

val ranged : string
(** A model of two cubes, one of which comes from (12, y, 0), with y in [-5, 5]; they meet where -2 < y < 2. *)

val model : string
(** Two cubes that meet, bind and bounce, and a wall. *)

val request : id:int -> string -> json -> json

val setup : json list
(** Defines the cube as [s1], the tetrahedron as [s2] and loads the model as [m1]; ids from 1. *)

val valid : (string * json) list
(** Methods with params that have answers after {!setup}. *)
