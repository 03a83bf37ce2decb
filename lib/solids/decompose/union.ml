module Polygons = Hashtbl.Make (struct
    type t = Homogeneous.t list

    let equal = List.equal Homogeneous.equal
    let hash list = List.fold_left (fun h p -> (h * 31) + Homogeneous.hash p) 7 list
  end)

let key (f : Cell.facet) = List.sort Homogeneous.compare (Array.to_list f.corners)

let all_behind corners planes =
  let behind plane = List.for_all (fun p -> Plane.side plane p <= 0) corners in
  List.for_all behind planes

(* The planes of the union, if it is convex: of two cells with a facet in common. *)
let planes_of_union (f : Cell.facet) (a : Cell.t) (b : Cell.t) =
  let others plane (cell : Cell.t) =
    List.filter_map (fun (h : Cell.facet) -> if Plane.equal h.plane plane then None else Some h.plane) cell
  in
  let of_a = others f.plane a and of_b = others (Plane.opposite f.plane) b in
  if all_behind (Cell.corners b) of_a && all_behind (Cell.corners a) of_b then Some (of_a @ of_b) else None

let of_planes box planes =
  let clip cell plane =
    match Cell.clip cell plane with
    | Some cell -> cell
    | None -> Scc_base.Bug.fail __POS__ "a union without volume"
  in
  List.fold_left clip box planes

let merge ~tick box cells =
  let live = Scc_data.Growable.create () in
  let owners = Polygons.create 256 and waiting = Queue.create () in
  let at key = Option.value ~default:[] (Polygons.find_opt owners key) in
  let enter cell =
    let number = Scc_data.Growable.length live in
    Scc_data.Growable.push live (Some cell);
    let facet f =
      let key = key f in
      (match at key with [ other ] -> Queue.add (key, other, number) waiting | _ -> ());
      Polygons.replace owners key (number :: at key)
    in
    List.iter facet cell
  in
  let leave number cell =
    Scc_data.Growable.set live number None;
    let facet f = Polygons.replace owners (key f) (List.filter (fun n -> n <> number) (at (key f))) in
    List.iter facet cell
  in
  List.iter enter cells;
  while not (Queue.is_empty waiting) do
    tick ();
    let shared, i, j = Queue.take waiting in
    match (Scc_data.Growable.get live i, Scc_data.Growable.get live j) with
    | Some a, Some b -> (
        let same f = List.equal Homogeneous.equal (key f) shared in
        match planes_of_union (List.find same a) a b with
        | None -> ()
        | Some planes ->
          leave i a;
          leave j b;
          enter (of_planes box planes))
    | _ -> ()
  done;
  List.filter_map (Scc_data.Growable.get live) (List.init (Scc_data.Growable.length live) Fun.id)
