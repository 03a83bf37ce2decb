open Scc_exact

type mover = { mass : Mass.t option; velocity : Vec.t; spin : Vec.t }

let velocity_at m x =
  match m.mass with
  | None -> Vec.zero
  | Some b -> Vec.add m.velocity (Vec.cross m.spin (Vec.sub x b.centre))

let relative a b x = Vec.sub (velocity_at b x) (velocity_at a x)

let approaching a b (c : Near_contact.t) =
  let at x =
    let w = relative a b x in
    List.for_all (fun n -> Rat.sign (Vec.dot (Ivec.to_vec n) w) < 0) c.normals
  in
  List.exists at c.corners

(* {1 Bounce} *)

(* A row J of generalized normals: J q = n.w(x). *)
type row = { normal : Vec.t; corner : Vec.t }

(* What an impulse of size 1 along a row changes of one body that it pushes along [push]: M^-1 J^T, its share of
   it. *)
type change = { push : Vec.t; twist : Vec.t; velocity : Vec.t; spin : Vec.t }

let change (b : Mass.t) inverse row push =
  let twist = Vec.cross (Vec.sub row.corner b.centre) push in
  { push; twist; velocity = Vec.scale (Rat.div Rat.one b.mass) push; spin = Mat.apply inverse twist }

(* The first body is pushed along -n, the second along n. *)
let changes sign rows m =
  let prepare b =
    let inverse = Mass.inverse_inertia b in
    Array.map (fun row -> change b inverse row (Vec.scale sign row.normal)) rows
  in
  Option.map prepare m.mass

(* J_k M^-1 J_l^T: what an impulse along the row l changes of J_k q. *)
let gram rows sides =
  let product k l =
    let of_side cs =
      Rat.add (Vec.dot cs.(k).push cs.(l).velocity) (Vec.dot cs.(k).twist cs.(l).spin)
    in
    List.fold_left (fun sum cs -> Rat.add sum (of_side cs)) Rat.zero (List.filter_map Fun.id sides)
  in
  let n = Array.length rows in
  let lower = Array.init n (fun k -> Array.init (k + 1) (product k)) in
  Array.init n (fun k -> Array.init n (fun l -> if l <= k then lower.(k).(l) else lower.(l).(k)))

let two = Rat.of_int 2

(* q + 2 M^-1 J^T x. *)
let moved (m : mover) changes x =
  match changes with
  | None -> m
  | Some cs ->
    let velocity = ref m.velocity and spin = ref m.spin in
    Array.iteri
      (fun k x ->
         if Rat.sign x <> 0 then begin
           velocity := Vec.axpy (Rat.mul two x) cs.(k).velocity !velocity;
           spin := Vec.axpy (Rat.mul two x) cs.(k).spin !spin
         end)
      x;
    { m with velocity = !velocity; spin = !spin }

type response = Bounced of mover * mover | Persistent

let compare_rows p q =
  let c = Vec.compare p.normal q.normal in
  if c <> 0 then c else Vec.compare p.corner q.corner

(* For y = -q and x its projection on N, which is a cone: y - x is orthogonal to x and has no positive product with
   any element of N. So |q + 2x| = |q| in the kinetic metric, that is the energy is kept; and for each row
   J (q + x) >= 0, hence J (q + 2x) = 2 J (q + x) - J q >= -J q.
   Impulses come in pairs on one line, n and -n at the corner: momentum and angular momentum are kept.
   x = 0 iff J q >= 0 for all rows. *)
let reflect a b normals =
  let row (n, corner) = { normal = Ivec.to_vec n; corner } in
  let rows = Array.of_list (List.sort_uniq compare_rows (List.map row normals)) in
  let target = Array.map (fun r -> Rat.neg (Vec.dot r.normal (relative a b r.corner))) rows in
  if not (Array.exists (fun t -> Rat.sign t > 0) target) then Persistent
  else
    let of_a = changes (Rat.of_int (-1)) rows a and of_b = changes Rat.one rows b in
    let x = Nnls.solve ~gram:(gram rows [ of_a; of_b ]) ~target in
    Bounced (moved a of_a x, moved b of_b x)

let bounce a b contacts =
  let contacts = List.map (fun c -> (c, approaching a b c)) contacts in
  let at ((c : Near_contact.t), normals) =
    List.concat_map (fun n -> List.map (fun corner -> (n, corner)) c.corners) normals
  in
  let all ((c : Near_contact.t), approaches) = if approaches then at (c, c.normals) else [] in
  match reflect a b (List.concat_map at (Inner_corners.counting contacts)) with
  | Bounced _ as response -> response
  | Persistent -> reflect a b (List.concat_map all contacts)

(* {1 Bind and split} *)

let at_rest = { mass = None; velocity = Vec.zero; spin = Vec.zero }

let whole parts =
  let mass = Mass.join (List.map fst parts) in
  let sum f = List.fold_left (fun s (b, m) -> Vec.add s (f b m)) Vec.zero parts in
  let momentum = sum (fun b (m : mover) -> Mass.momentum b ~velocity:m.velocity) in
  let turning =
    sum (fun b (m : mover) ->
        Mass.angular_momentum b ~velocity:m.velocity ~spin:m.spin ~about:mass.centre)
  in
  {
    mass = Some mass;
    velocity = Vec.scale (Rat.div Rat.one mass.mass) momentum;
    spin = Mass.turn_rate mass turning;
  }

let bind movers =
  let moving = List.filter_map (fun (m : mover) -> Option.map (fun b -> (b, m)) m.mass) movers in
  if List.compare_lengths moving movers < 0 then at_rest else whole moving

let piece whole = function
  | None -> at_rest
  | Some (b : Mass.t) ->
    let spin = match whole.mass with None -> Vec.zero | Some _ -> whole.spin in
    { mass = Some b; velocity = velocity_at whole b.centre; spin }
