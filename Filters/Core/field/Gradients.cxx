// SPDX-License-Identifier: BSD-3-Clause
#include "field/Gradients.h"

#include "Questions.h"

namespace geodesic
{

void Gradients::add(const IncomingSegment& piece)
{
  if (piece.kind == IncomingSegment::Kind::Window && piece.distance > 0.0)
  {
    const Hop hop = this->hopBefore(piece.ray);
    if (hop.isOne())
    {
      this->open_.push_back({ this->result_.size(), hop, { hop.face } });
    }
  }
  this->result_.push_back(gradientOf(this->field_.mesh(), piece));
}

// Another rank must follow the ray if this rank knows no face behind the halfedge, but the owner of
// the halfedge's face may.
Gradients::Hop Gradients::hopBefore(IncomingRay ray) const
{
  const MeshPartition& part = this->field_.surface();
  const Id face = TriangleMesh::faceOf(ray.halfedge);
  if (isInSpace(part.mesh(), ray) || !part.mesh().isBoundary(ray.halfedge) || part.isOwn(face))
  {
    return {};
  }
  const RankAddress owned = part.ownerOf(face);
  ray.halfedge = TriangleMesh::inCopy(ray.halfedge, owned.id);
  return { owned, ray };
}

// Asks the owners of the faces that the rays enter. A ray that comes to a face again goes in a
// circle of faces without area.
void Gradients::finish()
{
  Exchange& exchange = this->field_.surface().exchange();
  while (exchange.isTrueAnywhere(!this->open_.empty()))
  {
    Questions questions(exchange);
    for (std::size_t i = 0; i < this->open_.size(); ++i)
    {
      const Hop& hop = this->open_[i].hop;
      questions.ask(hop.face.rank, i, hop.ray);
    }
    std::vector<Open> goingOn;
    questions.exchangeAnswers(
      [&](MessageReader& question, Message& answer)
      {
        const TriangleMesh& mesh = this->field_.mesh();
        const IncomingRay ray = backToDirectionInSpace(mesh, question.get<IncomingRay>());
        put(answer, Answer{ inSpace(mesh, ray.halfedge, ray.direction), this->hopBefore(ray) });
      },
      [&](std::size_t i, MessageReader& reader)
      {
        const auto answer = reader.get<Answer>();
        Open& open = this->open_[i];
        this->result_[open.point] = answer.gradient;
        if (answer.hop.isOne() && open.passed.insert(answer.hop.face).second)
        {
          open.hop = answer.hop;
          goingOn.push_back(std::move(open));
        }
      });
    this->open_ = std::move(goingOn);
  }
}

}
