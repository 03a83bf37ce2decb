open Scc_geometry

type t = { part : int; feature : Feature.t }

let equal a b = a.part = b.part && Feature.equal a.feature b.feature

let compare a b =
  Int.compare a.part b.part <?> fun () -> Feature.compare a.feature b.feature

let on part sites = List.filter_map (fun s -> if s.part = part then Some s.feature else None) sites
let hash a = (a.part * 65599) + Feature.hash a.feature
