module Table = Hashtbl.Make (struct
    type t = int

    let equal = Int.equal

    (* Keys are v * n + w: multiply so that neighbouring edges spread over the buckets. *)
    let hash k = (k * 0x2545F491) land max_int
  end)

type t = {
  count : int;  (* of vertices: the directed edge v, w has the key v * count + w *)
  faces : int array array;
  directed : (int * int) Table.t;  (* the first face that runs along it, and where in the tuple *)
  repeated : (int * int * int * int) list;  (* face, later face, v, w; in reverse order *)
}

let key s v w = (v * s.count) + w

let next (face : int array) i = face.(if i + 1 = Array.length face then 0 else i + 1)

let fold_edges f start (face : int array) =
  let acc = ref start in
  Array.iteri (fun i v -> acc := f !acc v (next face i)) face;
  !acc

let make count faces =
  let directed = Table.create (4 * Array.length faces) in
  let s = { count; faces; directed; repeated = [] } in
  let repeated = ref [] in
  let add f i v w =
    match Table.find_opt directed (key s v w) with
    | None -> Table.add directed (key s v w) (f, i)
    | Some (g, _) -> repeated := (g, f, v, w) :: !repeated
  in
  Array.iteri (fun f face -> Array.iteri (fun i v -> add f i v (next face i)) face) faces;
  { s with repeated = !repeated }

let across s v w = Table.find s.directed (key s w v)

(* The uses of each unordered edge: (face, whether it runs from the smaller to the greater). *)
let uses s =
  let table = Table.create (2 * Array.length s.faces) in
  let add f () v w =
    let k = if v < w then key s v w else key s w v in
    Table.replace table k ((f, v < w) :: Option.value ~default:[] (Table.find_opt table k))
  in
  Array.iteri (fun f face -> fold_edges (add f) () face) s.faces;
  table

(* Walks over the faces from [root]; [step f] gives the neighbours of [f] with what to note at them.
   [note] holds the notes, None where the walk has not been. Returns the faces met, the root first. *)
let walk step note root value =
  note.(root) <- Some value;
  let rec go met = function
    | [] -> List.rev met
    | f :: rest ->
      let enter rest (g, value) =
        match note.(g) with
        | Some _ -> rest
        | None ->
          note.(g) <- Some value;
          g :: rest
      in
      go (f :: met) (List.fold_left enter rest (step f))
  in
  go [] [ root ]

let is_turned side = Option.value ~default:false side

(* If every unordered edge lies in exactly two faces and one can turn some faces over so that all
   orientations agree: the smaller choice of faces to turn in each piece. *)
let turned s =
  let table = uses s in
  let two = Table.fold (fun _ l ok -> ok && List.length l = 2) table true in
  if not two then None
  else
    let side = Array.make (Array.length s.faces) None in
    let neighbours f =
      let turned = is_turned side.(f) in
      let add acc v w =
        let k = if v < w then key s v w else key s w v in
        match Table.find table k with
        | [ (a, d); (b, e) ] ->
          let g = if a = f then b else a in
          (g, if Bool.equal d e then not turned else turned) :: acc
        | _ -> acc
      in
      fold_edges add [] s.faces.(f)
    in
    let agree _ l ok =
      ok
      &&
      match l with
      | [ (a, d); (b, e) ] ->
        let same_side = Option.equal Bool.equal side.(a) side.(b) in
        a <> b && Bool.equal same_side (not (Bool.equal d e))
      | _ -> false
    in
    let smaller = ref [] in
    let piece root =
      if Option.is_none side.(root) then begin
        let met = walk neighbours side root false in
        let yes, no = List.partition (fun f -> is_turned side.(f)) met in
        let few = if List.compare_lengths yes no <= 0 then yes else no in
        smaller := List.rev_append few !smaller
      end
    in
    Array.iteri (fun f _ -> piece f) s.faces;
    if Table.fold agree table true then Some (List.sort Int.compare !smaller) else None

let open_edges s =
  let doubled = Table.create 16 in
  List.iter
    (fun (_, _, v, w) -> Table.replace doubled (key s (Int.min v w) (Int.max v w)) ())
    s.repeated;
  let add f acc v w =
    if Table.mem s.directed (key s w v) || Table.mem doubled (key s (Int.min v w) (Int.max v w)) then acc
    else Polyhedron_fault.Open_edge (f, v, w) :: acc
  in
  let found = ref [] in
  Array.iteri (fun f face -> found := fold_edges (add f) !found face) s.faces;
  List.rev !found

let edge_faults s =
  let repeated =
    List.rev_map (fun (g, f, v, w) -> Polyhedron_fault.Repeated_edge (g, f, v, w)) s.repeated
  in
  let turned_faces = match repeated with [] -> None | _ :: _ -> turned s in
  match turned_faces with
  | Some (_ :: _ as faces) -> List.map (fun f -> Polyhedron_fault.Turned_face f) faces
  | Some [] | None -> List.rev_append (List.rev repeated) (open_edges s)

let pieces s =
  let seen = Array.make (Array.length s.faces) None in
  let neighbours f = fold_edges (fun acc v w -> (fst (across s v w), true) :: acc) [] s.faces.(f) in
  let roots = ref [] in
  let piece root =
    if Option.is_none seen.(root) then begin
      ignore (walk neighbours seen root true);
      roots := root :: !roots
    end
  in
  Array.iteri (fun f _ -> piece f) s.faces;
  List.rev !roots

let edge_compare (a, b) (c, d) =
  Int.compare a c <?> fun () -> Int.compare b d

let unordered s =
  Table.fold (fun k l acc -> ((k / s.count, k mod s.count), List.rev l) :: acc) (uses s) []
  |> List.sort (fun (e, _) (f, _) -> edge_compare e f)

let edges s = Array.map fst (Array.of_list (unordered s))
let unordered_count s = Table.length (uses s)
let ordered_count s = Table.length s.directed
