open Scc_geometry

type t = { taken : (string, unit) Hashtbl.t; last : (string, int) Hashtbl.t }

let besides (set : Polyhedron.ifs) =
  let taken = Hashtbl.create 64 in
  let take (name, _) = Hashtbl.replace taken name () in
  Array.iter take set.ifs_vertices;
  Array.iter take set.ifs_faces;
  { taken; last = Hashtbl.create 16 }

let rec next ?(from = 1) t prefix =
  let k = Option.fold ~none:from ~some:succ (Hashtbl.find_opt t.last prefix) in
  Hashtbl.replace t.last prefix k;
  let name = Printf.sprintf "%s%d" prefix k in
  if Hashtbl.mem t.taken name then next t prefix
  else begin
    Hashtbl.replace t.taken name ();
    name
  end
