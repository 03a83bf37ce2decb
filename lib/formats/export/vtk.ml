open Scc_exact
open Scc_rigid
open Scc_calculus

let number = Floats.text
let folder path = Filename.remove_extension path
let name k = Printf.sprintf "step-%06d.vtp" k

(* {1 What is there} *)

type cell = { leaf : int; part : int; process : int; bond : int; velocity : Vec.t; corners : int list }

type drawn = {
  mutable points : Vec.t list;
  mutable count : int;
  mutable lines : cell list;
  mutable faces : cell list;
}

let point d v =
  d.points <- v :: d.points;
  d.count <- d.count + 1;
  d.count - 1

let part m d process (p : State.process) (l : State.leaf) i =
  let placed = State.placed m l i in
  let first = d.count in
  Array.iter (fun v -> ignore (point d v)) (Placed.vertices placed);
  Array.iter
    (fun (_, around) ->
       let corners = List.map (fun c -> first + c) (Array.to_list around) in
       d.faces <- { leaf = l.leaf; part = i; process; bond = -1; velocity = p.velocity; corners } :: d.faces)
    placed.solid.polyhedron.faces

let bond m d process (p : State.process) number (b : State.bond) =
  let at (f : State.finish) = point d (State.centroid m (State.leaf_of p f.at)) in
  let one = at b.one in
  let two = at b.two in
  d.lines <-
    { leaf = b.one.at; part = -1; process; bond = number b.name; velocity = p.velocity; corners = [ one; two ] }
    :: d.lines

let draw m bond_number (s : State.t) =
  let d = { points = []; count = 0; lines = []; faces = [] } in
  Array.iteri
    (fun k (p : State.process) ->
       let leaf (l : State.leaf) = Array.iteri (fun i _ -> part m d k p l i) m.Model.leaves.(l.leaf).parts in
       Array.iter leaf p.leaves;
       Array.iter (bond m d k p bond_number) p.bonds)
    s.processes;
  d

(* {1 Files} *)

let array put ?(components = 1) ~kind name items =
  put
    (Printf.sprintf "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"ascii\">\n" kind name
       components);
  List.iter (fun item -> put item; put "\n") items;
  put "</DataArray>\n"

let integers put name items = array put ~kind:"Int32" name (List.map string_of_int items)

(* Texts stand as the numbers of their bytes, each text ended by a 0. *)
let texts put name items =
  put
    (Printf.sprintf "<Array type=\"String\" Name=\"%s\" NumberOfTuples=\"%d\" format=\"ascii\">\n" name
       (List.length items));
  let bytes s = List.map (fun c -> string_of_int (Char.code c)) (List.of_seq (String.to_seq s)) in
  List.iter (fun s -> put (String.concat " " (bytes s @ [ "0" ])); put "\n") items;
  put "</Array>\n"

let triple v = String.concat " " (List.map number (Array.to_list (Floats.point v)))

let cells put kind cells =
  put (Printf.sprintf "<%s>\n" kind);
  array put ~kind:"Int64" "connectivity"
    (List.map (fun c -> String.concat " " (List.map string_of_int c.corners)) cells);
  let ends, _ =
    List.fold_left
      (fun (ends, n) c ->
         let n = n + List.length c.corners in
         (n :: ends, n))
      ([], 0) cells
  in
  array put ~kind:"Int64" "offsets" (List.rev_map string_of_int ends);
  put (Printf.sprintf "</%s>\n" kind)

let step (f : Film.t) figure time put =
  let m = Film.model f in
  let channels = ref [] in
  let number_of name =
    match List.assoc_opt name !channels with
    | Some i -> i
    | None ->
      let i = List.length !channels in
      channels := !channels @ [ (name, i) ];
      i
  in
  let d = draw m number_of (Film.at f time) in
  let lines = List.rev d.lines and faces = List.rev d.faces in
  let all = lines @ faces in
  put "<?xml version=\"1.0\"?>\n";
  put "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n";
  put "<FieldData>\n";
  put "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">";
  put (number (Floats.of_rat time));
  put "</DataArray>\n";
  texts put "time" [ Rat.to_string time ];
  texts put "leaves" (List.map (fun (l : Model.leaf) -> l.name) (Array.to_list m.leaves));
  texts put "families" (List.map (fun (f : Figure.family) -> f.name) (Array.to_list (Figure.families figure)));
  texts put "bonds" (List.map fst !channels);
  put "</FieldData>\n";
  put
    (Printf.sprintf
       "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"0\" NumberOfLines=\"%d\" NumberOfStrips=\"0\" \
        NumberOfPolys=\"%d\">\n"
       d.count (List.length lines) (List.length faces));
  put "<CellData>\n";
  integers put "leaf" (List.map (fun c -> c.leaf) all);
  integers put "part" (List.map (fun c -> c.part) all);
  integers put "family" (List.map (fun c -> Figure.family figure ~leaf:c.leaf) all);
  integers put "fixed" (List.map (fun c -> if m.leaves.(c.leaf).fixed then 1 else 0) all);
  integers put "process" (List.map (fun c -> c.process) all);
  integers put "bond" (List.map (fun c -> c.bond) all);
  array put ~components:3 ~kind:"Float64" "velocity" (List.map (fun c -> triple c.velocity) all);
  put "</CellData>\n<Points>\n";
  array put ~components:3 ~kind:"Float64" "Points" (List.rev_map triple d.points);
  put "</Points>\n";
  cells put "Lines" lines;
  cells put "Polys" faces;
  put "</Piece>\n</PolyData>\n</VTKFile>\n"

let series path times put =
  let base = Filename.basename (folder path) in
  put "<?xml version=\"1.0\"?>\n";
  put "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  List.iteri
    (fun k time ->
       put
         (Printf.sprintf "<DataSet timestep=\"%s\" file=%s/>\n"
            (number (Floats.of_rat time))
            (Xml.quoted (base ^ "/" ^ name k))))
    times;
  put "</Collection>\n</VTKFile>\n"

let files f ~path ~times =
  let figure = Figure.make (Film.model f) in
  let step k time = (Filename.concat (folder path) (name k), step f figure time) in
  List.mapi step times @ [ (folder path ^ ".pvd", series path times) ]
