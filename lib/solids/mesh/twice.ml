(* The corners from the least one on. *)
let from_least (c : int array) =
  let n = Array.length c in
  let least = ref 0 in
  Array.iteri (fun i v -> if v < c.(!least) then least := i) c;
  Array.to_list (Array.init n (fun i -> c.((!least + i) mod n)))

(* Different faces: [many] is how often one is there, and [kept] how many of these stay: 0 as long as that is
   open. *)
type face = { sides : ((int * int) * int) list; many : int; mutable kept : int }

(* At an edge: its faces with their directions, and how many of them are open. *)
type edge = { mutable faces : (face * int) list; mutable unknown : int }

let sides corners =
  let n = Array.length corners in
  let side k =
    let a : int = corners.(k) and b = corners.((k + 1) mod n) in
    ((Int.min a b, Int.max a b), if a < b then 1 else -1)
  in
  List.init n side

(* How many of a face make an edge even whose other faces are known. *)
let wanted edge face =
  let own = List.filter (fun (f, _) -> f == face) edge.faces in
  let others = List.filter (fun (f, _) -> f != face) edge.faces in
  match own with
  | [ (_, way) ] ->
    let sum = List.fold_left (fun n (f, way) -> n + (way * f.kept)) 0 others in
    let balanced = -sum * way in
    if balanced >= 1 && balanced <= face.many then Some balanced
    else
      let count = List.fold_left (fun n (f, _) -> n + f.kept) 0 others in
      Some (if count land 1 = 1 then 1 else 2)
  | _ -> None

(* The number that most edges want, the least one of several; 1 if none does. *)
let chosen votes =
  let count k = List.length (List.filter (Int.equal k) votes) in
  let better best k = if count k > count best || (count k = count best && k < best) then k else best in
  match votes with [] -> 1 | k :: rest -> List.fold_left better k rest

let decide faces =
  let edges = Hashtbl.create 256 in
  let at key =
    match Hashtbl.find_opt edges key with
    | Some edge -> edge
    | None ->
      let edge = { faces = []; unknown = 0 } in
      Hashtbl.replace edges key edge;
      edge
  in
  let enter face (key, way) =
    let edge = at key in
    edge.faces <- (face, way) :: edge.faces;
    if face.kept = 0 then edge.unknown <- edge.unknown + 1
  in
  List.iter (fun face -> List.iter (enter face) face.sides) faces;
  let queue = Queue.create () in
  let decided edge =
    if edge.unknown = 1 then List.iter (fun (f, _) -> if f.kept = 0 then Queue.add f queue) edge.faces
  in
  let know face kept =
    face.kept <- kept;
    let one (key, _) =
      let edge = at key in
      edge.unknown <- edge.unknown - 1;
      decided edge
    in
    List.iter one face.sides
  in
  let vote face (key, _) =
    let edge = at key in
    if edge.unknown = 1 then wanted edge face else None
  in
  let rec follow () =
    match Queue.take_opt queue with
    | None -> ()
    | Some face ->
      if face.kept = 0 then know face (chosen (List.filter_map (vote face) face.sides));
      follow ()
  in
  let start face =
    if face.kept = 0 then begin
      List.iter (fun (key, _) -> decided (at key)) face.sides;
      follow ()
    end
  in
  List.iter start faces;
  let rest face =
    if face.kept = 0 then begin
      know face 1;
      follow ()
    end
  in
  List.iter rest faces

let single faces =
  let known = Hashtbl.create 256 in
  let keyed = List.map (fun (name, c) -> (from_least c, (name, c))) faces in
  let count (key, _) = Hashtbl.replace known key (1 + Option.value (Hashtbl.find_opt known key) ~default:0) in
  List.iter count keyed;
  if Hashtbl.length known = List.length keyed then faces
  else begin
    let found = Hashtbl.create 256 in
    let different (key, (_, c)) =
      if Hashtbl.mem found key then None
      else begin
        let many = Hashtbl.find known key in
        let face = { sides = sides c; many; kept = (if many = 1 then 1 else 0) } in
        Hashtbl.replace found key face;
        Some face
      end
    in
    decide (List.filter_map different keyed);
    let stays (key, _) =
      let face = Hashtbl.find found key in
      face.kept > 0 && begin
        Hashtbl.replace found key { face with kept = face.kept - 1 };
        true
      end
    in
    List.map snd (List.filter stays keyed)
  end
