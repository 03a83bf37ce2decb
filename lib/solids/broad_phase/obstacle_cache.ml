open Scc_geometry

module Made = Scc_data.Once.Make (struct
    type t = Solid.t * Solid.t

    let equal ((a, b) : t) ((c, d) : t) = Int.equal a.id c.id && Int.equal b.id d.id
    let hash ((a, b) : t) = (a.id * 65599) + b.id
  end)

type t = Obstacle.t Made.t

let create () = Made.create (fun (a, b) -> Obstacle.make a b)

let find cache (a : Solid.t) (b : Solid.t) =
  if a.id = Solid.derived || b.id = Solid.derived then Obstacle.make a b else Made.find cache (a, b)
