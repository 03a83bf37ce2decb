open Scc_verify
module Loaded = Scc_session.Loaded
module Union = Scc_polyhedra.Union

let models = "../../../specs/models"

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let load file =
  let read_file name = try Ok (read (Filename.concat models name)) with Sys_error e -> Error e in
  Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name:file (read (Filename.concat models file)))

let () =
  let files = List.filter (fun f -> Filename.check_suffix f ".sc") (Array.to_list (Sys.readdir models)) in
  let one file =
    match load file with
    | Error _ -> ()
    | Ok l when Zone_check.refused l.model <> [] -> ()
    | Ok l ->
      let u = match l.uncertain with Some u -> u | None -> Scc_symbolic.Start.known l.model l.declared in
      let initial = Result.get_ok (Scc_semantics.Network.initial l.semantics l.declared) in
      let context = Scc_symbolic.Instant.context l.semantics in
      match Scc_symbolic.Start.zones context u ~initial ~keeps_time:false with
      | Error _ -> Printf.printf "%s: not well-formed\n%!" file
      | Ok zones ->
        let t = Sys.time () in
        let deadline = t +. 20. in
        let surroundings = { Check.default.surroundings with stop = (fun () -> if Sys.time () > deadline then Some Scc_explore.Limits.Seconds else None) } in
        let formulas = List.map (fun (c : Scc_property.Property.check) -> c.formula) l.checks in
        let parameters = Scc_calculus.Ranges.box l.model.ranges in
        (match Zone_proof.attempt { Check.default with surroundings } l.semantics u ~declared:l.declared ~parameters zones formulas with
         | None_found reason -> Printf.printf "%s: %s (%.1f)\n%!" file reason (Sys.time () -. t)
         | Proved { invariant; proofs } ->
           Printf.printf "%s: %d locations (%.1f)\n%!" file (List.length invariant.locations) (Sys.time () -. t);
           List.iter2 (fun (c : Scc_property.Property.check) (p : Scc_symbolic.Proof.t) ->
               let all = Union.of_polyhedron parameters in
               let covers u = Union.is_empty (Union.difference all u) in
               let word = if covers p.sets.holds then "holds" else if covers p.sets.fails then "violated" else if Union.is_empty p.sets.holds && Union.is_empty p.sets.fails then "-" else "in part" in
               if word <> "-" then Printf.printf "   %s: %s   (%s)\n%!" c.name word c.text) l.checks proofs)
  in
  List.iter one (List.sort String.compare files)
