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

type contact = { first : int; second : int; normal : Ivec.t; corner : Vec.t }
type encounter = { one : int; two : int; contacts : Near_contact.t list }

let compare_contacts p q =
  Int.compare p.first q.first <?> fun () ->
    Int.compare p.second q.second <?> fun () ->
      Ivec.compare p.normal q.normal <?> fun () -> Vec.compare p.corner q.corner

(* A body has two slots: its velocity and its spin. What an impulse of size 1 along a row J changes of a body that
   it pushes along [push] is M^-1 J^T, its share of it. *)
let parts (movers : mover array) inverses i corner push =
  match movers.(i).mass with
  | None -> []
  | Some (b : Mass.t) ->
    let twist = Vec.cross (Vec.sub corner b.centre) push in
    [
      (2 * i, push, Vec.scale (Rat.div Rat.one b.mass) push);
      ((2 * i) + 1, twist, Mat.apply (Lazy.force inverses.(i)) twist);
    ]

(* The first body is pushed along -n, the second along n: J q = n.w(x). *)
let row movers inverses c =
  let n = Ivec.to_vec c.normal in
  let part i push = parts movers inverses i c.corner push in
  List.sort
    (fun (i, _, _) (j, _, _) -> Int.compare i j)
    (part c.first (Vec.neg n) @ part c.second n)

(* Impulses come in pairs on one line, n and -n at the corner: momentum and angular momentum are kept. *)
let reflect movers contacts =
  let inverse m =
    lazy (match m.mass with Some b -> Mass.inverse_inertia b | None -> Scc_base.Bug.fail __POS__ "a fixed body")
  in
  let inverses = Array.map inverse movers in
  let rows = List.map (row movers inverses) (List.sort_uniq compare_contacts contacts) in
  let q = Array.init (2 * Array.length movers) (fun k ->
      let m = movers.(k / 2) in
      if k land 1 = 0 then m.velocity else m.spin)
  in
  let moved after i (m : mover) =
    match m.mass with None -> m | Some _ -> { m with velocity = after.(2 * i); spin = after.((2 * i) + 1) }
  in
  Option.map (fun after -> Array.mapi (moved after) movers) (Reflection.reflect q (Array.of_list rows))

(* What counts of the contacts of two bodies; all of those that approach, if it would give no change. *)
let counting movers { one; two; contacts } =
  let a = movers.(one) and b = movers.(two) in
  let at ((c : Near_contact.t), normals) =
    List.concat_map
      (fun normal -> List.map (fun corner -> { first = one; second = two; normal; corner }) c.corners)
      normals
  in
  let contacts = List.map (fun c -> (c, approaching a b c)) contacts in
  let all ((c : Near_contact.t), approaches) = if approaches then at (c, c.normals) else [] in
  let approach c = Rat.sign (Vec.dot (Ivec.to_vec c.normal) (relative a b c.corner)) < 0 in
  match List.concat_map at (Inner_corners.counting contacts) with
  | counted when List.exists approach counted -> counted
  | _ -> List.concat_map all contacts

let bounce_all movers encounters = reflect movers (List.concat_map (counting movers) encounters)

type response = Bounced of mover * mover | Persistent

let bounce a b contacts =
  match bounce_all [| a; b |] [ { one = 0; two = 1; contacts } ] with
  | Some after -> Bounced (after.(0), after.(1))
  | None -> Persistent

(* {1 Bind and split} *)

let pushed ~at impulse m =
  match m.mass with
  | None -> m
  | Some b ->
    {
      m with
      velocity = Vec.axpy (Rat.div Rat.one b.mass) impulse m.velocity;
      spin = Vec.add m.spin (Mass.turn_rate b (Vec.cross (Vec.sub at b.centre) impulse));
    }

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
