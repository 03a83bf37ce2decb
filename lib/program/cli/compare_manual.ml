open Cmdliner

let text =
  [
    `S Manpage.s_description;
    `P
      "Explores two models and tells whether they are equivalent: whether whoever sees their transitions, \
       and not their states, can tell them apart. If so, it says how: by a shortest trace of one that the \
       other does not have, if there is one, and by a formula that is true of the first and false of the \
       second. Both are checked on the two graphs before they are printed.";
    `P
      "Labels are those of $(b,scc trace), $(b,bind(a, p.right, q.left\\)) say, with the two ends (and the \
       bonds of a reaction) in the order of their texts. Where a model is at rest time passes for ever: \
       $(b,time(forever\\)).";
    `P
      "What is drawn at one instant is one transition, since the order of draws says nothing: \
       $(b,{keep(b, r.top, s.top\\), release(a, p.right, q.left\\)} chance(1/6\\)), with all that is drawn in the \
       order of the texts, and the product of the chances. $(b,--rename) and $(b,--hide) are of the single draws; \
       what is hidden of them is left out. Nor is it seen in which order free ends choose how they let go \
       ($(b,choose(...\\))). Draws that have not been explored to the end of their instant are not known.";
    `P
      "Only labels are compared, and they tell neither places nor motions. So equivalent models are equivalent by \
       themselves, and not in every network: beside a third body, which one of them may hit and the other not, \
       they may differ. No relation here is a congruence for putting networks side by side. Properties about \
       places, distances, velocities and behaviours are not preserved by any of them; those about events are, as \
       far as the relation sees time and silent transitions.";
    `S "RELATIONS";
    `I
      ( "$(b,trace)",
        "the same sequences of labels. Silent transitions are not seen, nor is the passing of time." );
    `I
      ( "$(b,weak)",
        "weak bisimilarity: each transition of one is answered by the other with the same label, with silent \
         ones before and after it, and so on from there. The passing of time is silent." );
    `I
      ( "$(b,branching)",
        "branching bisimilarity: as weak, and the silent transitions of an answer change nothing that could \
         be done. This is the default. Neither relation looks at divergence: to be silent for ever is no \
         difference." );
    `I
      ( "$(b,strong)",
        "bisimilarity, transition by transition. A passing of time is a transition $(b,time), whatever its \
         duration; consecutive passings, with nothing else possible in between, are one." );
    `I
      ( "$(b,timed)",
        "as strong, and durations count: time is additive, $(b,time(1\\)) and then $(b,time(2\\)) is \
         $(b,time(3\\)), and a longer passing is looked at wherever the other model meets an instant." );
    `P
      "Each of strong, branching, weak and trace implies the next one; between models, timed implies strong.";
    `S "FORMULAS";
    `I ("$(b,<a>f)", "some transition a leads to where f is true; $(b,[a]f): every transition a does.");
    `I
      ( "$(b,<<a>>f), $(b,[[a]]f)",
        "the same with silent transitions before and after a. With $(b,tau): by silent transitions, or by none." );
    `I ("$(b,(f until <a>g\\))", "silent transitions while f is true, then a, and then g is true.");
    `I ("$(b,(f until g\\))", "silent transitions, or none, while f is true, to where g is true.");
    `I ("$(b,<time(d\\)>f)", "after exactly d, over any instants on the way, f can be true.");
    `S "GRAPHS";
    `P
      "A file whose name ends in $(b,.aut) is a graph, as $(b,scc explore), CADP, mCRL2 and others write it. \
       $(b,tau) and $(b,i) are silent, $(b,time(1/2\\)) and $(b,time(forever\\)) pass time, and a transition \
       $(b,unexplored) says that not all transitions of its state are known.";
    `S "BOUNDS";
    `P
      "Bounds are for each of the two models; those of seconds and of memory are for the comparison as well. \
       When a model was not explored completely, two models are never called equivalent, and different only \
       if what is known makes sure of it.";
  ]
  @ Options.diagnostics_man
  @ [
    `S Manpage.s_examples;
    `Pre "  scc compare a.sc b.sc --modulo weak --rename left=p --hide bounce";
    `Pre "  scc compare chain.sc chain.sc --left n=3 --right n=4 --modulo trace";
    `Pre "  scc compare model.aut specification.aut --modulo branching --json";
  ]
