open Scc_geometry

module Table = Hashtbl.Make (struct
    type t = int * int

    let equal (a, b) (c, d) = Int.equal a c && Int.equal b d
    let hash (a, b) = (a * 65599) + b
  end)

type t = Obstacle.t Table.t

let create () = Table.create 16

let find cache (a : Solid.t) (b : Solid.t) =
  if a.id = Solid.derived || b.id = Solid.derived then Obstacle.make a b
  else
    let key = (a.id, b.id) in
    match Table.find_opt cache key with
    | Some o -> o
    | None ->
      let o = Obstacle.make a b in
      Table.add cache key o;
      o
